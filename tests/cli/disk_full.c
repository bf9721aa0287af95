/* A disk that is full from the N-th write on (BRUNT_FULL_AT, counted from 1): preloaded into a
   process, write, writev, pwrite and fsync of files that are open for writing then fail with ENOSPC. Pipes,
   terminals and devices go on. With BRUNT_FULL_NAME, only files with this in their names count: one
   rank's piece of one frame. With BRUNT_COUNT, the number of writes is left in that file.
   With BRUNT_SHORT, of these writes each third is interrupted before its first byte (EINTR), and
   each third takes a part only: 1 byte, or half of them, or all but one. */
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

/* What a write of size bytes shall take: all, a part of them, or -1: it is interrupted. */
static ssize_t allowed(int descriptor, size_t size) {
  static atomic_long writes;
  struct stat status;
  if (getenv("BRUNT_SHORT") == NULL) return (ssize_t)size;
  if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return (ssize_t)size;
  const long call = atomic_fetch_add(&writes, 1);
  if (call % 3 == 0) return -1;
  if (call % 3 == 1 || size < 2) return (ssize_t)size;
  const size_t parts[] = {1, size / 2, size - 1};
  return (ssize_t)parts[call / 3 % 3];
}

ssize_t write(int descriptor, const void* data, size_t size) {
  static ssize_t (*real)(int, const void*, size_t);
  if (real == NULL) *(void**)&real = dlsym(RTLD_NEXT, "write");
  if (full(descriptor)) return errno = ENOSPC, -1;
  const ssize_t most = allowed(descriptor, size);
  if (most < 0) return errno = EINTR, -1;
  return real(descriptor, data, (size_t)most);
}

ssize_t writev(int descriptor, const struct iovec* parts, int n) {
  static ssize_t (*real)(int, const struct iovec*, int);
  if (real == NULL) *(void**)&real = dlsym(RTLD_NEXT, "writev");
  if (full(descriptor)) return errno = ENOSPC, -1;
  size_t size = 0;
  for (int i = 0; i < n; ++i) size += parts[i].iov_len;
  const ssize_t most = allowed(descriptor, size);
  if (most < 0) return errno = EINTR, -1;
  if ((size_t)most == size) return real(descriptor, parts, n);
  struct iovec part[16];
  size_t left = (size_t)most;
  int used = 0;
  for (; used < n && used < 16 && left > 0; ++used) {
    part[used] = parts[used];
    if (part[used].iov_len > left) part[used].iov_len = left;
    left -= part[used].iov_len;
  }
  return real(descriptor, part, used);
}

ssize_t pwrite64(int descriptor, const void* data, size_t size, off64_t at) {
  static ssize_t (*real)(int, const void*, size_t, off64_t);
  if (real == NULL) *(void**)&real = dlsym(RTLD_NEXT, "pwrite64");
  if (full(descriptor)) return errno = ENOSPC, -1;
  const ssize_t most = allowed(descriptor, size);
  if (most < 0) return errno = EINTR, -1;
  return real(descriptor, data, (size_t)most, at);
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
