# The libraries that dapple stands on; each is used behind few files.
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(fmt REQUIRED)
find_package(hwy REQUIRED)
find_package(tl-expected REQUIRED)
find_package(PNG REQUIRED)
find_package(OpenEXR REQUIRED CONFIG)
find_package(PkgConfig REQUIRED)
pkg_check_modules(XXHASH REQUIRED IMPORTED_TARGET libxxhash>=0.8)
