/* A program for "robovac run" in C: drives straight; backs off and turns away when it bumps.
 *
 *   cc -O2 -o bounce bounce.c
 *   robovac run bounce.c --command ./bounce --room bedroom
 *
 * Each line that it reads is one JSON object with the sensors; each line that it writes is a command. See
 * docs/program-protocol.md. The values that it needs are found by their names, so it needs no library.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Readings of all sensors take about 1 KB; a laser scan can add 10 KB. */
static char line[65536];

/* What follows "name": in the line; an empty text if it isn't there. */
static const char *value(const char *name) {
    char key[64];
    snprintf(key, sizeof key, "\"%s\":", name);
    const char *at = strstr(line, key);
    return at ? at + strlen(key) : "";
}

static int flag(const char *name) { return strncmp(value(name), "true", 4) == 0; }

int main(void) {
    /* The greeting: robot, time step, seed. */
    if (!fgets(line, sizeof line, stdin)) return 1;
    unsigned long random = strtoul(value("seed"), NULL, 10) * 2654435761ul + 1;
    puts("{\"ready\":\"behaviour\"}");
    fflush(stdout);

    int backing = 0, turning = 0; /* steps of 15 ms that are left */
    while (fgets(line, sizeof line, stdin)) {
        int bumped = flag("bump_left") || flag("bump_right");
        if (bumped && !backing) {
            random = (random * 1103515245ul + 12345ul) & 0x7ffffffful;
            backing = 20;
            turning = 60 + (int)((random >> 16) % 60);
            printf("{\"left\":-200,\"right\":-200,\"print\":[\"bump, %d steps to turn\"]}\n", turning);
        } else if (backing > 0) {
            backing--;
            puts("{\"left\":-200,\"right\":-200}");
        } else if (turning > 0) {
            turning--;
            puts("{\"left\":-150,\"right\":150}");
        } else {
            puts("{\"left\":300,\"right\":300}");
        }
        fflush(stdout);
    }
    return 0;
}
