/// Read by ThreadSanitizer at start. OpenNI2, which pcl_io links, unlocks a mutex that another object owns.
extern "C" const char* __tsan_default_suppressions();
extern "C" const char* __tsan_default_suppressions() {
    return "mutex:libOpenNI2\n";
}
