#ifndef PINBALL_CONTACT_EXPORT_H
#define PINBALL_CONTACT_EXPORT_H

/* PINBALL_API marks what a shared library exports: all else in it is compiled with hidden visibility. C and C++. */
#if defined(__GNUC__)
#define PINBALL_API __attribute__((visibility("default")))
#else
#define PINBALL_API
#endif

#endif
