/* Values that both sides of the tests with Cyclone DDS make from a seed, in C and C++ alike. */
#pragma once

#include <stdint.h>

/* splitmix64 (Steele, Lea and Flood 2014) */
static inline uint64_t fill_next(uint64_t* state) {
    uint64_t z = (*state += UINT64_C(0x9e3779b97f4a7c15));
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

/* Any finite value of some million steps. */
static inline double fill_real(uint64_t* state) {
    return ((double)(fill_next(state) % 8000001U) - 4000000.0) / 64.0;
}

/* How many elements; many bytes now and then, so that samples come in pieces. */
static inline uint32_t fill_count(uint64_t* state) {
    return (uint32_t)(fill_next(state) % 5U);
}
static inline uint32_t fill_byte_count(uint64_t* state) {
    const uint64_t pick = fill_next(state);
    return (uint32_t)(pick % 11U == 0U ? 200000U + pick % 1000U : pick % 300U);
}

/* Writes a text of up to 40 bytes, with letters beyond ASCII, into @p to (41 bytes). */
static inline void fill_text(uint64_t* state, char* to) {
    uint64_t letters = fill_next(state) % 21U;
    for (; letters > 0U; --letters) {
        const uint64_t pick = fill_next(state) % 96U;
        if (pick == 95U) {
            *to++ = '\xc3';
            *to++ = '\xa4';
        } else {
            *to++ = (char)(' ' + (int)pick);
        }
    }
    *to = '\0';
}
