// SPDX-License-Identifier: BSD-3-Clause
#ifndef ArrayNames_h
#define ArrayNames_h

/// The name of every array between the filters. What each holds: the headers of the filters, and
/// the table in README.md.
namespace medial
{
namespace names
{
// vtkShareOutObjects: field data, a single value
constexpr const char* ObjectId = "ObjectId";

// vtkImageBoundary: points of the mask
constexpr const char* Mask = "Mask";
// ... field data, passed on to all later filters; one of the first two
constexpr const char* IsoValue = "IsoValue";
constexpr const char* Label = "Label";
constexpr const char* BettiSegmentation = "BettiSegmentation";
constexpr const char* BettiBoundary = "BettiBoundary";
constexpr const char* PaddedVoxels = "PaddedVoxels";
constexpr const char* FilledCavities = "FilledCavities";
constexpr const char* FilledVoxels = "FilledVoxels";
constexpr const char* DroppedPieces = "DroppedPieces";
constexpr const char* DroppedVoxels = "DroppedVoxels";
constexpr const char* CutVoxels = "CutVoxels";

// vtkCleanScan: points; Normals too
constexpr const char* InputPoint = "InputPoint";
// ... field data, single values; passed on to all later filters
constexpr const char* NoiseBefore = "NoiseBefore";
constexpr const char* NoiseAfter = "NoiseAfter";
constexpr const char* DroppedOutliers = "DroppedOutliers";
constexpr const char* ThinnedSamples = "ThinnedSamples";
constexpr const char* SmoothingRounds = "SmoothingRounds";
constexpr const char* Thinning = "Thinning";

// vtkBoundarySamples: points of the samples
constexpr const char* Normals = "Normals";
constexpr const char* Spacing = "Spacing";
constexpr const char* SourceCell = "SourceCell"; // and of the surface's cells
// ... field data, single values; passed on to all later filters
constexpr const char* BettiSolid = "BettiSolid"; // vtkPolarBalls with a solid, too
constexpr const char* SolidVolume = "SolidVolume";
constexpr const char* SolidArea = "SolidArea";
constexpr const char* MergedPoints = "MergedPoints";
constexpr const char* DroppedPolygons = "DroppedPolygons";
constexpr const char* FilledHoles = "FilledHoles";
constexpr const char* RefinementRounds = "RefinementRounds";

// Input of vtkPolarBalls: field data, a single value
constexpr const char* SampleResolution = "SampleResolution";

// every filter from vtkPolarBalls to vtkPowerCrust: field data, one entry for each warning; none of these
// arrays where there is no warning
constexpr const char* WarningCode = "WarningCode";
constexpr const char* WarningText = "WarningText";
constexpr const char* WarningCount = "WarningCount";
constexpr const char* WarningPlace = "WarningPlace";
constexpr const char* WarningHasPlace = "WarningHasPlace";
constexpr const char* WarningDoubtsSolid = "WarningDoubtsSolid";

// vtkPolarBalls: points, one for each ball
constexpr const char* Radius = "Radius"; // and of vtkMedialMeshReader
constexpr const char* InnerRadius = "InnerRadius";
constexpr const char* Side = "Side";
constexpr const char* TouchesGuard = "TouchesGuard";
constexpr const char* Volume = "Volume";
constexpr const char* PoleVolume = "PoleVolume";
// ... field data, one entry for each sample
constexpr const char* Samples = "Samples";
constexpr const char* SampleInnerBall = "SampleInnerBall";
constexpr const char* SampleOuterBall = "SampleOuterBall";
constexpr const char* SampleNormals = "SampleNormals"; // only where they are known
// ... field data, lists of samples, one list for each ball
constexpr const char* BallSampleOffsets = "BallSampleOffsets";
constexpr const char* BallSamples = "BallSamples";
// ... field data, single values
constexpr const char* NumberOfSamples = "NumberOfSamples";
constexpr const char* NumberOfDuplicates = "NumberOfDuplicates";
constexpr const char* NumberOfInnerBalls = "NumberOfInnerBalls";
constexpr const char* NumberOfOuterBalls = "NumberOfOuterBalls";
constexpr const char* NumberOfHiddenBalls = "NumberOfHiddenBalls";
constexpr const char* SampleSpacing = "SampleSpacing";
constexpr const char* MergeTolerance = "MergeTolerance";
constexpr const char* BettiPowerShape = "BettiPowerShape";
// ... points of the samples; InnerBall, OuterBall too
constexpr const char* SamplingQuality = "SamplingQuality";
constexpr const char* DuplicateOf = "DuplicateOf";

// vtkMedialAxis: points
constexpr const char* BallId = "BallId";
constexpr const char* MaximumInscribedSphereRadius = "MaximumInscribedSphereRadius";
// ... cells
constexpr const char* PolygonId = "PolygonId";
constexpr const char* SiteSamples = "SiteSamples";
constexpr const char* ObjectAngle = "ObjectAngle";
constexpr const char* Lambda = "Lambda";
constexpr const char* ErosionThickness = "ErosionThickness"; // and points
// ... field data, one entry for each ball
constexpr const char* BallOwner = "BallOwner";
constexpr const char* BallVolume = "BallVolume";
constexpr const char* BallPoleVolume = "BallPoleVolume";
// ... field data, single values
constexpr const char* BettiAxis = "BettiAxis";
constexpr const char* BettiUnprunedAxis = "BettiUnprunedAxis";
constexpr const char* TopologyKept = "TopologyKept";
constexpr const char* Certificate = "Certificate";
constexpr const char* Fallback = "Fallback";
constexpr const char* Kappa = "Kappa";
constexpr const char* FilledGaps = "FilledGaps";
constexpr const char* SampleDiagonal = "SampleDiagonal";
constexpr const char* NumberOfOffAxisBalls = "NumberOfOffAxisBalls";

// vtkMedialPartDecomposition: cells
constexpr const char* PartId = "PartId";     // and column of the table
constexpr const char* PartRank = "PartRank"; // and column of the table
constexpr const char* PartLevel = "PartLevel";
// ... and an array for each measure, see MeasureTraits::cellArray in Core/Parts/Measures.h
// ... field data, single values
constexpr const char* NumberOfParts = "NumberOfParts";
constexpr const char* SuggestedThreshold = "SuggestedThreshold"; // a component for each measure
// ... columns of the table of parts, beside one for each measure, MeasureTraits::name; Volume too
constexpr const char* Dimension = "Dimension";
constexpr const char* Level = "Level";
constexpr const char* MinimumRadius = "MinimumRadius";
constexpr const char* Contacts = "Contacts";
constexpr const char* Neighbors = "Neighbors";
constexpr const char* NeckRatio = "NeckRatio";
constexpr const char* OnLoop = "OnLoop";
constexpr const char* Centroid = "Centroid";
constexpr const char* PrincipalLengths = "PrincipalLengths";
constexpr const char* Bounds = "Bounds";
// ... contact curves: cells, and lists of parts in the field data, one list for each curve
constexpr const char* ContactId = "ContactId";
constexpr const char* ContactPartOffsets = "ContactPartOffsets";
constexpr const char* ContactParts = "ContactParts";
// ... topology graph: points; PartId, OnLoop too
constexpr const char* NodeId = "NodeId"; // and of its cells
constexpr const char* Degree = "Degree";

// vtkMedialPrune: cells
constexpr const char* KeepReason = "KeepReason";
constexpr const char* InputCell = "InputCell"; // and of what was removed
// ... cells of what was removed, and column of the history
constexpr const char* Iteration = "Iteration";
// ... columns of the history
constexpr const char* Word = "Word";
constexpr const char* ByHand = "ByHand";
constexpr const char* Measure = "Measure";
constexpr const char* Threshold = "Threshold";
constexpr const char* Passes = "Passes";
constexpr const char* PartsBefore = "PartsBefore";
constexpr const char* PartsAfter = "PartsAfter";
constexpr const char* Candidates = "Candidates";
constexpr const char* Removed = "Removed";
constexpr const char* Refused = "Refused";
constexpr const char* RefusedByTopology = "RefusedByTopology";
constexpr const char* RefusedIsolated = "RefusedIsolated";
constexpr const char* RefusedProtected = "RefusedProtected";
constexpr const char* TopologyChanges = "TopologyChanges";
constexpr const char* Betti = "Betti";
constexpr const char* VolumeRemoved = "VolumeRemoved";

// vtkMedialMeshReader: points and cells; Radius too
constexpr const char* Type = "Type";
// vtkMedialCenterlines: points; MaximumInscribedSphereRadius too
// ... cells; Length too
constexpr const char* BranchId = "BranchId";
constexpr const char* BranchNodes = "BranchNodes";
constexpr const char* MeanRadius = "MeanRadius"; // and MinimumRadius
// ... nodes: points; NodeId, Degree too
constexpr const char* AtPlate = "AtPlate";
// ... field data, a single value
constexpr const char* OpenedVoids = "OpenedVoids";

// vtkPowerCrust: points
constexpr const char* SampleId = "SampleId";
// ... cells; PartId, PartRank too
constexpr const char* InnerBall = "InnerBall";
constexpr const char* OuterBall = "OuterBall";
// ... field data, single values; Volume too
constexpr const char* BettiCrust = "BettiCrust";
constexpr const char* Closed = "Closed";
constexpr const char* Manifold = "Manifold";
constexpr const char* PutBackBalls = "PutBackBalls";
constexpr const char* InsertedBalls = "InsertedBalls";
constexpr const char* RefusedBalls = "RefusedBalls";
constexpr const char* Rounds = "Rounds";
constexpr const char* MaximumClearance = "MaximumClearance";
constexpr const char* MovedAtMost = "MovedAtMost";
constexpr const char* MovedBy = "MovedBy";
constexpr const char* Verdict = "Verdict";
// ... field data, a text for each reason; no array where there is none
constexpr const char* VerdictReasons = "VerdictReasons";

// vtkLocalThickness: points
constexpr const char* Thickness = "Thickness";
constexpr const char* ThicknessBall = "ThicknessBall";
constexpr const char* Separation = "Separation";
constexpr const char* SeparationBall = "SeparationBall";
// ... means: columns; and field data, single values
constexpr const char* Quantity = "Quantity";
constexpr const char* Weight = "Weight";
constexpr const char* Mean = "Mean";
constexpr const char* Deviation = "Deviation";
constexpr const char* Minimum = "Minimum";
constexpr const char* Maximum = "Maximum";
constexpr const char* Number = "Number";
constexpr const char* Histogram = "Histogram";
constexpr const char* Margin = "Margin";
constexpr const char* VolumeShare = "VolumeShare";
// ... thin places: columns; PartId too
constexpr const char* Place = "Place";
constexpr const char* Depth = "Depth";
constexpr const char* AxisPoint = "AxisPoint";
// vtkPlatesAndRods: points; Thickness too, and of the surface's cells
constexpr const char* SheetWidth = "SheetWidth";
constexpr const char* WidthRatio = "WidthRatio";
constexpr const char* PlateOrRod =
  "PlateOrRod"; // and cells, cells of the surface, column of the table
constexpr const char* ElementId = "ElementId"; // the same
// ... columns of the table; Volume, Centroid, Neighbors too
constexpr const char* Area = "Area";
constexpr const char* Length = "Length";
constexpr const char* MeanThickness = "MeanThickness";
constexpr const char* MinimumThickness = "MinimumThickness";
constexpr const char* MaximumThickness = "MaximumThickness";
constexpr const char* Direction = "Direction";
// ... field data of the table, lists of elements, one list for each element
constexpr const char* NeighborOffsets = "NeighborOffsets";
constexpr const char* NeighborElements = "NeighborElements";
// ... field data of axis and table, single values
constexpr const char* NumberOfPlates = "NumberOfPlates";
constexpr const char* NumberOfRods = "NumberOfRods";
constexpr const char* PlateVolume = "PlateVolume";
constexpr const char* RodVolume = "RodVolume";
constexpr const char* PlatePlateJunctions = "PlatePlateJunctions";
constexpr const char* PlateRodJunctions = "PlateRodJunctions";
constexpr const char* RodRodJunctions = "RodRodJunctions";
// vtkMorphometry: columns, beside one for each quantity, Quantity::name in Core/Measuring/Morphometry.h;
// Betti, BettiSolid and Verdict too
constexpr const char* Name = "Name";
constexpr const char* Unit = "Unit";
// ... field data, a text for each column
constexpr const char* ColumnUnits = "ColumnUnits";
}
}

#endif
