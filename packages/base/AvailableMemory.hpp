#pragma once

namespace harmos::base {

/// Memory [byte] that this process may still take without being ended: the least of what the machine has free, what its
/// control group leaves, and its own limit on address space. Infinite where none of them can be read. Of this moment;
/// others may take it first.
double availableMemory();

}  // namespace harmos::base
