/* Preloaded into LinuxCNC for tests: a socket that would listen on all networks listens on this
   computer only. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <netinet/in.h>
#include <sys/socket.h>

int bind(int descriptor, const struct sockaddr *wanted, socklen_t size)
{
    int (*next)(int, const struct sockaddr *, socklen_t) = dlsym(RTLD_NEXT, "bind");
    const struct sockaddr_in *internet = (const struct sockaddr_in *)wanted;

    if (wanted->sa_family == AF_INET && internet->sin_addr.s_addr == htonl(INADDR_ANY)) {
        struct sockaddr_in local = *internet;
        local.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        return next(descriptor, (struct sockaddr *)&local, sizeof local);
    }
    return next(descriptor, wanted, size);
}
