#pragma once

namespace leitstand {

/// Returns freed memory to the system, also between blocks that are still in use. The allocator itself
/// returns only the end of each of its areas; each thread has an area. Any thread; takes some milliseconds
/// for each 100 MB. Does nothing if the C library has no such function.
void returnFreeHeap();

}  // namespace leitstand
