/// Read by ThreadSanitizer at start. OpenNI2, which pcl_io links, unlocks a mutex that another object owns;
/// GDAL, which OpenCV links, takes two of its own in both orders while it is loaded.
/// Fast DDS locks by pthread_mutex_clocklock, which the sanitizer does not see, and hands sample memory
/// between threads by atomics of its own, which it does not see either: the bytes copied there are the only
/// accesses in our code. It reads the local time in several threads, which the C library guards by a lock of
/// its own. While one participant is made, its threads read what the making one still writes.
extern "C" const char* __tsan_default_suppressions();
extern "C" const char* __tsan_default_suppressions() {
    return "mutex:libOpenNI2\n"
           "deadlock:libgdal\n"
           "mutex:libfastrtps.so\n"
           "deadlock:libfastrtps.so\n"
           "race:leitstand::detail::RawType::\n"
           "race:tzset_internal\n"
           "race:eprosima::fastrtps::rtps::RTPSDomainImpl::createParticipant\n";
}

/// What libraries do that are built without the sanitizer is not ours to judge, also where they do it with
/// memory of ours: OpenCV works in threads of TBB.
extern "C" const char* __tsan_default_options();
extern "C" const char* __tsan_default_options() {
    return "ignore_noninstrumented_modules=1";
}
