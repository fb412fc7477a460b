# A thin front for CMake: what it builds lies in build/release, with links to the programs here.
PREFIX ?= /usr/local
PROGRAMS = ray ray_bvh store_scene describe_scene dapple

all:
	@sh tools/setup/install.sh --check build
	cmake --preset release -DDAPPLE_BUILD_TESTS=OFF >/dev/null
	cmake --build --preset release

demo:
	./run demo

test:
	./run test

# MEASURE=1 measures anew first.
report:
	./run report $(if $(MEASURE),measure)

install: all
	DESTDIR='$(DESTDIR)' cmake --install build/release --prefix '$(PREFIX)'

clean:
	rm -rf build $(PROGRAMS) demo-output

.PHONY: all demo test report install clean
