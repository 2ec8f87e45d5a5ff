#pragma once

/// From now on the first SIGINT or SIGTERM only sets a flag, so that the run can stop between two iterations and leave
/// readable files; the second one ends the program at once.
void catchInterrupts();

bool wasInterrupted();
