// Loaded into a browser before its own libraries, gives pseudo terminals the control lines (RTS, DTR) that the kernel's
// lack: Firefox takes nothing without them for a serial port.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdarg.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

// Major numbers of pseudo terminals (Linux, Documentation/admin-guide/devices.txt).
static int is_pseudo_terminal(int file) {
    struct stat status;
    return fstat(file, &status) == 0 && S_ISCHR(status.st_mode) && major(status.st_rdev) >= 136 && major(status.st_rdev) <= 143;
}

int ioctl(int file, unsigned long request, ...) {
    static int lines = TIOCM_DTR | TIOCM_RTS;
    static int (*kernels)(int, unsigned long, ...);
    va_list rest;
    va_start(rest, request);
    void *argument = va_arg(rest, void *);
    va_end(rest);
    if ((request == TIOCMGET || request == TIOCMSET) && is_pseudo_terminal(file)) {
        if (request == TIOCMGET) *(int *)argument = lines;
        else lines = *(int *)argument;
        return 0;
    }
    if (!kernels) kernels = (int (*)(int, unsigned long, ...))dlsym(RTLD_NEXT, "ioctl");
    return kernels(file, request, argument);
}
