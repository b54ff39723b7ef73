// A library that is no plug-in.
extern "C" int stranger();
int stranger() {
  return 7;
}
