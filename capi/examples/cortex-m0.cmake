# A Cortex-M0 without an operating system.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_C_FLAGS_INIT "-mcpu=cortex-m0 -mthumb")
set(CMAKE_BUILD_TYPE MinSizeRel CACHE STRING "")
# A program cannot be linked before there is start-up code.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
# Which of carom's archives.
set(CAROM_TARGET thumbv6m-none-eabi)
