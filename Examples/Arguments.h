// SPDX-License-Identifier: BSD-3-Clause
#ifndef Arguments_h
#define Arguments_h

#include <array>
#include <optional>
#include <string>
#include <vector>

/// The values of the command line.
struct Arguments
{
  std::string input;               ///< the only one, where there is no cohort
  std::vector<std::string> inputs; ///< all
  std::string output = "out";
  bool writesResults = false; ///< into that folder; always where there is no cohort
  std::string schedule = "noise";
  bool automatic = false; ///< choose the iterations from the data
  double trim = 0;        ///< rims of the axis, in spacings
  bool splitAtNecks = false;
  bool keepTopology = true;
  std::vector<int> partsToRemove;
  bool dropInvalid = false;   ///< leave points with NaN or infinite coordinates out
  double mergeTolerance = -1; ///< within it samples count as one; negative: what rounding explains
  bool clean = false;   ///< take outliers and noise from the points, which are the samples then
  bool points = false;  ///< the vertices of a mesh are the samples, not its triangles
  double fineness = 0;  ///< of the samples of triangles; 0: the default of vtkBoundarySamples
  double spacing = 0;   ///< largest one of them; 0: chosen
  bool wrap = false;    ///< sample the surface around polygons that bound no solid
  double wrapWidth = 0; ///< of the gaps that it crosses; 0: chosen
  std::optional<double> iso;       ///< of an image: its solid are the voxels of at least this value
  std::optional<double> label;     ///< or those of this one
  int series = 0;                  ///< of a folder of DICOM files, from 1 on; 0: the only one
  std::optional<int> fillCavities; ///< largest one that is filled, in voxels
  std::optional<int> smallestPiece; ///< that is kept, in voxels
  bool largestPiece = false;        ///< keep that alone
  std::optional<double> gaussian;   ///< smooths the voxels, standard deviation in voxels
  bool morphometry = false;
  std::string unit;                            ///< of the coordinates; empty: not known
  std::optional<std::array<double, 6>> bounds; ///< that morphometry measures in
  double margin = 0;                           ///< inside them
  std::string cohort;                          ///< the table of many objects
  std::string settings;                        ///< the options that can change a row of it
  int threads = 0;                             ///< 0: as many as the machine has
  bool medialMeshes = false;                   ///< write .ma files
  bool exportParts = false;                    ///< write the mesh of each part
  bool picture = false;
  bool page = false; ///< write report.html
  bool strict = false;
  bool quiet = false;
  bool help = false;
};

/// @throw UsageError  says which word is wrong and what is expected instead
Arguments parseArguments(int argc, char* argv[]);

/// The text of --help.
std::string usage();

#endif
