/* A disk that is full from the N-th write on (BRUNT_FULL_AT, counted from 1): preloaded into a
   process, write, writev, pwrite and fsync of files that are open for writing then fail with ENOSPC. Pipes,
   terminals and devices go on. With BRUNT_FULL_NAME, only files with this in their names count: one
   rank's piece of one frame. With BRUNT_COUNT, the number of writes is left in that file. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

static atomic_long calls;

/* True where BRUNT_FULL_NAME is not set or stands in the name of the file. */
static int is_meant(int descriptor) {
  const char* wanted = getenv("BRUNT_FULL_NAME");
  char link[64], name[4096];
  if (wanted == NULL) return 1;
  snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t length = readlink(link, name, sizeof name - 1);
  if (length < 0) return 0;
  name[length] = '\0';
  return strstr(name, wanted) != NULL;
}

static int full(int descriptor) {
  struct stat status;
  if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return 0;
  if (!is_meant(descriptor)) return 0;
  const char* at = getenv("BRUNT_FULL_AT");
  const long call = atomic_fetch_add(&calls, 1) + 1;
  return at != NULL && atol(at) > 0 && call >= atol(at);
}

ssize_t write(int descriptor, const void* data, size_t size) {
  static ssize_t (*real)(int, const void*, size_t);
  if (real == NULL) *(void**)&real = dlsym(RTLD_NEXT, "write");
  if (full(descriptor)) return errno = ENOSPC, -1;
  return real(descriptor, data, size);
}

ssize_t writev(int descriptor, const struct iovec* parts, int n) {
  static ssize_t (*real)(int, const struct iovec*, int);
  if (real == NULL) *(void**)&real = dlsym(RTLD_NEXT, "writev");
  if (full(descriptor)) return errno = ENOSPC, -1;
  return real(descriptor, parts, n);
}

ssize_t pwrite64(int descriptor, const void* data, size_t size, off64_t at) {
  static ssize_t (*real)(int, const void*, size_t, off64_t);
  if (real == NULL) *(void**)&real = dlsym(RTLD_NEXT, "pwrite64");
  if (full(descriptor)) return errno = ENOSPC, -1;
  return real(descriptor, data, size, at);
}

int fsync(int descriptor) {
  static int (*real)(int);
  if (real == NULL) *(void**)&real = dlsym(RTLD_NEXT, "fsync");
  if (full(descriptor)) return errno = ENOSPC, -1;
  return real(descriptor);
}

__attribute__((destructor)) static void report(void) {
  const char* name = getenv("BRUNT_COUNT");
  if (name == NULL) return;
  FILE* file = fopen(name, "w");
  if (file == NULL) return;
  fprintf(file, "%ld\n", atomic_load(&calls));
  fclose(file);
}
