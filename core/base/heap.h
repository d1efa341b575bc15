#pragma once

namespace leitstand {

/// Gives freed memory back to the system, also between blocks that are still in use. The allocator itself
/// gives back only the end of each of its areas; each thread has an area. Any thread; takes some milliseconds
/// for each 100 MB. Does nothing where the C library has no such function.
void returnFreeHeap();

}  // namespace leitstand
