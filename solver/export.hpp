#pragma once

/// PINBALL_API marks what a shared library exports: all else in it is compiled with hidden visibility.
#if defined(__GNUC__)
#define PINBALL_API __attribute__((visibility("default")))
#else
#define PINBALL_API
#endif
