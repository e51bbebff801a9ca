/* A library that does whatever a library can do wrong, as the environment says (HOSTILE). */
#define _GNU_SOURCE
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "properties/c_abi/tps_implementation.h"

static int is(const char* mode) {
  const char* wanted = getenv("HOSTILE");
  return wanted != NULL && strcmp(wanted, mode) == 0;
}

/* Needs a frame each: the sum is taken after the call. */
static int recursion(int depth) {
  volatile char frame[10000];
  frame[0] = (char)depth;
  return depth == 0x7fffffff ? 0 : recursion(depth + 1) + frame[0];
}

static tps_status collision_impulse(const tps_pair* pair, double m_A, double m_B, double c, double dp[3]) {
  (void)pair, (void)m_A, (void)m_B, (void)c;
  dp[0] = dp[1] = dp[2] = 0;
  if (is("segv")) raise(SIGSEGV);
  if (is("null")) *(volatile int*)0 = 1;
  if (is("abort")) abort();
  if (is("exit")) exit(0);
  if (is("_exit")) _exit(9);
  if (is("hang"))
    for (;;) {
    }
  if (is("sleep")) sleep(1000);
  if (is("recursion")) recursion(0);
  if (is("stop")) raise(SIGSTOP);
  if (is("fork_crash")) {
    if (fork() == 0) sleep(1000);
    raise(SIGSEGV);
  }
  if (is("session_hang")) {
    if (fork() == 0) setsid();
    sleep(1000);
  }
  if (is("kill_parent")) kill(getppid(), SIGTERM);
  if (is("prints")) printf("noise without an end");
  if (is("fakes_a_reply")) {
    puts("{\"seq\":1,\"out\":{}}");
    fflush(stdout);
  }
  if (is("closes")) {
    close(0);
    close(1);
    close(2);
  }
  if (is("changes_folder") && chdir("/") != 0) abort();
  if (is("floods_errors")) {
    for (int n = 0; n < 20000; ++n) fputs("EEEEEEEEEEEEEEE\n", stderr);
  }
  if (is("nan")) dp[0] = NAN;
  return TPS_ANSWERED;
}

static tps_implementation table;

__attribute__((constructor)) static void construct(void) {
  if (is("constructor_crash")) raise(SIGSEGV);
  if (is("constructor_exit")) exit(0);
  if (is("constructor_prints")) puts("{\"name\":\"another\"}");
}

const tps_implementation* tps_get_implementation(void) {
  table.version = is("other_version") ? TPS_IMPLEMENTATION_VERSION + 1 : TPS_IMPLEMENTATION_VERSION;
  table.name = is("no_name") ? NULL : "hostile";
  table.bits = is("no_bits") ? 0 : 53;
  table.collision_impulse = collision_impulse;
  if (is("wild_function")) memset(&table.collision_impulse, 0x10, sizeof table.collision_impulse);
  if (is("no_table")) return NULL;
  if (is("wild_table")) return (const tps_implementation*)16;
  if (is("odd_table")) return (const tps_implementation*)1;
  return &table;
}
