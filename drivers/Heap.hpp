#pragma once

/// Has the process keep memory that it frees, for what it asks for next. The C library would give large arrays back to
/// the system, again and again, which then clears their pages and maps them anew. Up to 256 MiB at the end of the heap
/// are kept; arrays of 8 MiB or more are given back at once all the same. With other C libraries than GNU's it does
/// nothing. An application that embeds Harmos decides for itself.
void keepFreedMemory();

/// Asks for the first 128 MiB of the heap in huge pages, which are mapped, and found by the processor, several hundred
/// times less often; for a share of them where so many `processes`, at least 1, divide a problem on this machine: each
/// has less to keep there, and clears what it asks for. Nothing where addresses are limited, where the user has set
/// MALLOC_TOP_PAD_ or MALLOC_TRIM_THRESHOLD_, or where the system has no huge pages. Large arrays keep small pages:
/// those that are given back and asked for anew would be cleared as a whole every time.
void useHugePages(int processes);
