#ifndef PINBALL_BASE_VERSION_H
#define PINBALL_BASE_VERSION_H

#include "export.h"

/** @file
 * The version of Pinball (semver.org; while the first number is 0, a new second number may change the interfaces), and
 * what the library was compiled for. C and C++.
 */

/* CMake takes the version of the project from these three lines. */
#define PINBALL_VERSION_MAJOR 0 /**< first number of #PINBALL_VERSION */
#define PINBALL_VERSION_MINOR 1 /**< second number of #PINBALL_VERSION */
#define PINBALL_VERSION_PATCH 0 /**< third number of #PINBALL_VERSION */

/** A macro's value as text. */
#define PINBALL_TEXT_OF(number) #number
/** The text of a version, of numbers that may be macros. */
#define PINBALL_VERSION_OF(major, minor, patch) PINBALL_TEXT_OF(major) "." PINBALL_TEXT_OF(minor) "." PINBALL_TEXT_OF(patch)
/** What the host was compiled with. */
#define PINBALL_VERSION PINBALL_VERSION_OF(PINBALL_VERSION_MAJOR, PINBALL_VERSION_MINOR, PINBALL_VERSION_PATCH)

#ifdef __cplusplus
extern "C" {
#endif

/** Version of the library that the host runs with, as #PINBALL_VERSION; never null. */
PINBALL_API const char* pinball_version(void);

/** The instruction set that the library was compiled for: "AVX-512", "AVX2", "AVX", "SSE2" or "generic". In a portable
 *  installation the dynamic loader has chosen among several libraries. */
PINBALL_API const char* pinball_instruction_set(void);

/** Numbers of type double that the kernels work at once: 8 with AVX-512, 4 with AVX2, 2 with SSE2. */
PINBALL_API int pinball_simd_width(void);

#ifdef __cplusplus
}
#endif

#endif
