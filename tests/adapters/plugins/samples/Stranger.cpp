// A library that is not a plug-in.
extern "C" int stranger();
int stranger() {
  return 7;
}
