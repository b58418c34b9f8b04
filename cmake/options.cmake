# What every target is compiled with.
find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

# Contracted multiply-adds would make results depend on the processor.
add_compile_options(-Wall -Wextra -ffp-contract=off)
if(CIGSIM_WERROR)
  add_compile_options(-Werror)
endif()
if(CIGSIM_SANITIZE)
  add_compile_options(-fsanitize=${CIGSIM_SANITIZE} -fno-omit-frame-pointer
                      -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${CIGSIM_SANITIZE})
  # SystemC's threads switch stacks behind the sanitizer's back: what it then believes of the stack
  # is wrong. Heap and globals stay watched.
  if(CIGSIM_SANITIZE MATCHES "address")
    add_compile_options(--param=asan-stack=0)
  endif()
endif()
if(CIGSIM_COVERAGE)
  add_compile_options(--coverage)
  add_link_options(--coverage)
endif()
include_directories(${PROJECT_SOURCE_DIR})

# Debian's SystemC is built as C++17; its headers check that every user says so.
add_compile_definitions(SC_CPLUSPLUS=201703L)
