#pragma once

#include <string>
#include <vector>

/// What Open MPI must not do when it starts, unless the user wants it to, as variables of the environment.
///
/// Its own handlers of SIGSEGV and others print stacks and may hang in a damaged heap for minutes, and it takes the
/// short-lived processes that read files for a mistake. A process that mpirun has not started needs no folder for its
/// session, which fails where many start at once. One that nothing has launched as one of several needs no daemon
/// beside it, no network and no list of devices: without them it starts in a quarter of the time. Several on one
/// machine talk through its memory, and do not look for networks, which takes 0.2 s. Other kinds of MPI do not know
/// these variables.
class OpenMpiSettings {
 public:
  /// Sets them, but those that are set already; to be called before MPI is initialised.
  OpenMpiSettings();
  /// To be called when MPI is initialised: takes away what was set for a process alone or for one machine, which
  /// processes that it starts would inherit, and those may be several.
  void takeBack();
  /// Processes that mpirun of Open MPI has started on this machine, this one included; 1 where it has not.
  static int processesHere();

 private:
  /// Sets a variable that is not set, until takeBack().
  void setForNow(const char* name, const char* value);

  std::vector<std::string> own_;  // names
};
