#pragma once

/// Has the process keep memory that it frees, for what it asks for next. The C library would give large arrays back to
/// the system, again and again, which then clears their pages and maps them anew. Up to 256 MiB at the end of the heap
/// are kept; arrays of 8 MiB or more are given back at once all the same. With other C libraries than GNU's it does
/// nothing. An application that embeds Harmos decides for itself.
void keepFreedMemory();
