/* The version of the library; that of the build system is checked against it. */
#ifndef DAPPLE_VERSION_H
#define DAPPLE_VERSION_H

#define DAPPLE_VERSION_MAJOR 0
#define DAPPLE_VERSION_MINOR 1
#define DAPPLE_VERSION_PATCH 0
#define DAPPLE_VERSION "0.1.0"

/* What the shared library exports. */
#if defined(__GNUC__)
#define DAPPLE_API __attribute__((visibility("default")))
#else
#define DAPPLE_API
#endif

#endif
