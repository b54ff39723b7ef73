# Finds the external libraries. tools/dependencies lists the Debian packages and
# why each is needed. A library that only one adapter needs is found there.

find_package(Threads REQUIRED)
find_package(CAF 0.17.6 REQUIRED COMPONENTS core io)
find_package(pugixml REQUIRED)
find_package(SQLite3 REQUIRED)
find_package(ICU REQUIRED COMPONENTS uc i18n)
find_package(fmt REQUIRED)
find_package(tl-expected REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(OpenSSL REQUIRED)

find_package(PkgConfig REQUIRED)
pkg_check_modules(RE2 REQUIRED IMPORTED_TARGET re2)
pkg_check_modules(MARIADB REQUIRED IMPORTED_TARGET libmariadb)
pkg_check_modules(ZEROMQ REQUIRED IMPORTED_TARGET libzmq)
pkg_check_modules(EDIT REQUIRED IMPORTED_TARGET libedit)

if(PARLOUR_TESTS)
  find_package(GTest)
  if(NOT GTest_FOUND)
    message(STATUS "tests: left out, GoogleTest is not installed")
  endif()
endif()
