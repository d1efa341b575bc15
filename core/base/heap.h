#pragma once

namespace leitstand {

/// Gives the memory of what was freed back to the system, wherever it lies between things that stay: the
/// allocator itself gives back only what lies at the end of its areas, of which each thread has one. Any
/// thread; takes some milliseconds for each 100 MB. Nothing where the C library has no such function.
void returnFreeHeap();

}  // namespace leitstand
