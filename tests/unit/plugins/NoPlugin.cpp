// A shared library that has nothing to do with Harmos.
extern "C" __attribute__((visibility("default"))) int answer();

int answer() {
  return 42;
}
