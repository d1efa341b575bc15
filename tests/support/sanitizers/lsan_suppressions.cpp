/// Read by LeakSanitizer at the end. x265, which only the simulation encodes by, does not release what the
/// rows of its loop filter hold when an encoder is closed. assimp does not release a kilobyte when a mesh is
/// damaged.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libx265.so\nleak:libassimp.so\n";
}
