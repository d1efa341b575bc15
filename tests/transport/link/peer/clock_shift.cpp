// The wall clock of this whole process, libraries too, is CLOCK_AHEAD seconds ahead of the computer's. Steady
// clocks are left alone, as they are on a robot whose date is wrong.
#include <cstdlib>
#include <ctime>

#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

namespace {

long ahead() {
    static const long seconds = [] {
        const char* text = std::getenv("CLOCK_AHEAD");
        return text == nullptr ? 0L : std::atol(text);
    }();
    return seconds;
}

}  // namespace

#if !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
extern "C" {

int clock_gettime(clockid_t clock, struct timespec* now) noexcept {
    const long result = syscall(SYS_clock_gettime, clock, now);
    if (result == 0 && (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE)) now->tv_sec += ahead();
    return static_cast<int>(result);
}

int gettimeofday(struct timeval* __restrict now, void* __restrict) noexcept {
    timespec time{};
    clock_gettime(CLOCK_REALTIME, &time);
    now->tv_sec = time.tv_sec;
    now->tv_usec = time.tv_nsec / 1000;
    return 0;
}

time_t time(time_t* now) noexcept {
    timespec time{};
    clock_gettime(CLOCK_REALTIME, &time);
    if (now != nullptr) *now = time.tv_sec;
    return time.tv_sec;
}
}
#else
// Sanitizers bring clocks of their own; the test that needs this one says so.
long unusedClockShift() {
    return ahead();
}
#endif
