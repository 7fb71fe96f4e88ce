// SPDX-License-Identifier: BSD-3-Clause
/**
 * The table of a schedule in the panel: ParaView's own, in which a measure is chosen from the names of
 * all measures instead of typed, and where a cell takes no text but a number that the filter can use. A
 * list above it takes the rows of a preset. A description asks for it by panel_widget="medial_schedule".
 */

#ifndef pqMedialSchedule_h
#define pqMedialSchedule_h

#include "pqStringVectorPropertyWidget.h"

class pqMedialSchedule : public pqStringVectorPropertyWidget
{
  Q_OBJECT

public:
  pqMedialSchedule(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);
};

#endif
