#pragma once

/// From now on SIGINT, SIGTERM and SIGUSR1 are remembered, so that a calculation can end by itself and save what it
/// has. A process that has not asked for them soon (wasInterrupted), or does not end soon afterwards, is ended with
/// exit code 130: the phase it is in, or a library, never looks up. What it was writing is removed, what it had written
/// stays. A second signal ends the process at once. SIGUSR1 is for mpirun of Open MPI, which hands it on to its ranks
/// and ends as they do; of SIGINT and SIGTERM it makes a SIGTERM for each, kills them a second later, and ends with 1.
/// A file that becomes larger than the system allows (ulimit -f) is an error of who writes it, and no signal; so is a
/// pipe that nobody reads any more, which must not cost the results of a run.
///
/// To be called once, before any other thread is started, and never by a library of Harmos: the signals of a process
/// belong to its program.
void catchInterrupts();
/// Whether there was one.
bool wasInterrupted();
