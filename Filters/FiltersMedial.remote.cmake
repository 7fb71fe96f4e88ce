# For VTK's folder Remote/: VTK then builds this module with its own. See "In VTK's own tree" in README.md.
set(MEDIAL_REPOSITORY "" CACHE STRING "Address or path of MedialAxis, for git")
set(MEDIAL_TAG "main" CACHE STRING "Branch, tag or commit of MedialAxis")
vtk_fetch_module(FiltersMedial
  "The medial axis of a solid, its parts, their pruning, and the way back to a surface"
  GIT_REPOSITORY "${MEDIAL_REPOSITORY}"
  GIT_TAG "${MEDIAL_TAG}"
  )
