# The libraries that dapple stands on; each is used behind few files.
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
find_package(hwy REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tl-expected REQUIRED)
find_package(PNG REQUIRED)
find_package(OpenEXR REQUIRED CONFIG)
find_package(PkgConfig REQUIRED)
pkg_check_modules(XXHASH REQUIRED IMPORTED_TARGET libxxhash>=0.8)
pkg_check_modules(JPEG REQUIRED IMPORTED_TARGET libjpeg)
pkg_check_modules(WEBP REQUIRED IMPORTED_TARGET libwebp)
pkg_check_modules(DRACO REQUIRED IMPORTED_TARGET draco)
find_package(meshoptimizer REQUIRED)

# FBX, COLLADA, 3DS and others; without it these formats are named in an error.
if(DAPPLE_ASSIMP)
  find_package(assimp QUIET CONFIG)
  if(NOT TARGET assimp::assimp)
    message(STATUS "assimp was not found (Debian: libassimp-dev): FBX, COLLADA, 3DS and other "
                   "formats that are read through it will not be imported")
  endif()
endif()
