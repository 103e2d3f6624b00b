# carom::carom is the library: its header, and the archive for what is being built.
#
# For a microcontroller (CMAKE_SYSTEM_NAME Generic) set CAROM_TARGET to the archive's processor before find_package:
# thumbv6m-none-eabi (M0, M0+), thumbv7m-none-eabi (M3), thumbv7em-none-eabihf (M4, M7 with FPU),
# thumbv8m.main-none-eabihf (M33 with FPU), thumbv8m.main-none-eabi (M33).
get_filename_component(_carom_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

if(CAROM_TARGET)
    set(_carom_archive "${_carom_prefix}/lib/carom/${CAROM_TARGET}/libcarom.a")
elseif(CMAKE_SYSTEM_NAME STREQUAL "Generic")
    set(carom_FOUND FALSE)
    set(carom_NOT_FOUND_MESSAGE "set CAROM_TARGET to the processor: see ${CMAKE_CURRENT_LIST_FILE}")
    return()
else()
    set(_carom_archive "${_carom_prefix}/lib/libcarom.a")
endif()

if(NOT EXISTS "${_carom_archive}")
    set(carom_FOUND FALSE)
    set(carom_NOT_FOUND_MESSAGE
        "${_carom_archive} is not there: `cargo xtask capi install --prefix ${_carom_prefix} --target ${CAROM_TARGET}` makes it")
    return()
endif()

if(NOT TARGET carom::carom)
    add_library(carom::carom STATIC IMPORTED)
    set_target_properties(carom::carom PROPERTIES
        IMPORTED_LOCATION "${_carom_archive}"
        INTERFACE_INCLUDE_DIRECTORIES "${_carom_prefix}/include")
endif()
