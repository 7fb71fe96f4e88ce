// SPDX-License-Identifier: BSD-3-Clause
#ifndef Ranks_h
#define Ranks_h

#include <string>

/// Which of several processes this is.
struct Rank
{
  int number = 0;  ///< from 0
  int count = 1;   ///< of processes
  std::string run; ///< the same for all of them, another one when they are started again
};

/// As the launcher says in the environment: mpirun of Open MPI (OMPI_COMM_WORLD_RANK and _SIZE) and MPICH
/// (PMI_RANK and _SIZE), srun (SLURM_PROCID and SLURM_NTASKS; only in a step, since a batch script itself has
/// them, too). One process alone where none does. The program isn't linked to MPI.
/// @throw UsageError  what the launcher says makes no sense
Rank rankOfLauncher();

#endif
