// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Schedule_h
#define medial_Schedule_h

#include "Base/Types.h"
#include "Parts/Measures.h"

#include <string>
#include <vector>

/// A schedule is the list of iterations that pruning works through. In words: "t5 t5 h0.5s a2s".
namespace medial
{
/// What the threshold of a length is counted in, and with its square that of an area.
enum class LengthUnit
{
  Samples,  ///< the unit of the samples' coordinates: h0.5, a0.5
  Diagonal, ///< the diagonal of the samples' bounding box; in words in per cent: h2%
  Spacing   ///< the mean spacing of the samples: h1s, a2s
};

/// One iteration of a schedule: decompose the axis into parts, measure them, remove the small ones.
///
/// Unlike the paper, an iteration repeats its passes until nothing changes. A removed part's
/// significance then passes to its most significant neighbor. Without that, a long feature that falls
/// apart into small parts would be removed piece by piece from its end. With it, what an iteration
/// removes at one place has together at most the threshold, if the measure adds up. With a single
/// pass, or with Topology::None, each part counts alone, as in the paper.
struct PruneIteration
{
  Measure measure = Measure::TriangleCount;
  double threshold = 5; ///< parts with at most this significance are removed
  int passes = 0;       ///< how often to repeat; 0: until nothing changes (the paper: 1)
  LengthUnit lengthUnit = LengthUnit::Samples; ///< of a threshold that is a length or an area
};

bool operator==(const PruneIteration& a, const PruneIteration& b);

/// A schedule with a name.
struct SchedulePreset
{
  const char* name;  ///< one word
  const char* words; ///< the schedule
  const char* what;  ///< what it removes, for people
};

/// All of them; the first one is the default. "High" in their words is how far the solid recedes
/// without a part, see Measure::HausdorffDistance.
const std::vector<SchedulePreset>& schedulePresets();

/// The words of the first preset.
const char* defaultSchedule();

/// Reads a schedule in words, separated by blanks or commas; no words: no iterations.
///
/// A word is the letter of a measure, a number, and for some measures a unit: t5 (at most 5 triangles),
/// v1% (at most one per cent of the volume), r2 (a length in the unit of the samples), r2% (in per cent
/// of the diagonal of the samples' bounding box), r2s (in mean spacings of the samples), a2s (in their square). It may
/// end with the number of passes: t5x1 for one pass, as in the paper; without, passes are repeated until nothing
/// changes. The name of a preset stands for its words.
/// @throw InvalidInput  which word is wrong, what is wrong with it, and how to write it
std::vector<PruneIteration> parseSchedule(const std::string& words);

/// One iteration from three texts, as a table for people to fill in gives them. No text is ever taken
/// for another number than it shows: "0,05", "5 %" and "" are errors.
/// @param measure    a name: TriangleCount
/// @param threshold  a number in the measure's unit, shares 0 ... 1: 5, 0.05 or 5e-2; a length may end
///                   with s, in spacings, or %, of the diagonal: 1s, 2%; an area with s, in square spacings
/// @param passes     a whole number; 0: until nothing changes
/// @throw InvalidInput  which of the three is wrong, and how to write it
PruneIteration parseIteration(
  const std::string& measure, const std::string& threshold, const std::string& passes);

/// What is wrong with the numbers of an iteration: a threshold that is no finite number, negative, or
/// above all values of its measure (see largestThreshold); a negative number of passes. Empty: nothing.
std::string faultOf(const PruneIteration& iteration);

/// The inverse of parseSchedule: reading its result gives the same schedule, thresholds to the last bit
/// (those of counts rounded down, which removes the same parts).
/// @param schedule  valid: faultOf says nothing
std::string scheduleWords(const std::vector<PruneIteration>& schedule);

/// The word of one iteration with its threshold to three digits, for people.
std::string shortWord(const PruneIteration& iteration);

/// How the words of a measure are written: tN, vP%, rX.
std::string wordPattern(const MeasureTraits& traits);
}

#endif
