# The Debian packages, ramure and python3-ramure: ./dev package.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ramure)
set(CPACK_PACKAGE_CONTACT "The Ramure authors <authors@ramure.org>")
file(READ ${CMAKE_SOURCE_DIR}/resources/package/description CPACK_COMPONENT_RAMURE_DESCRIPTION)
string(STRIP "${PROJECT_DESCRIPTION}\n${CPACK_COMPONENT_RAMURE_DESCRIPTION}" CPACK_COMPONENT_RAMURE_DESCRIPTION)
# Each package has a first line of its own; CPack puts this one, its usual one, before none.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${CMAKE_PROJECT_NAME} built using CMake")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL ramure python3-ramure)
set(CPACK_DEBIAN_RAMURE_PACKAGE_NAME ramure)
set(CPACK_DEBIAN_RAMURE_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Not linked against, but loaded: it draws the icons.
set(CPACK_DEBIAN_RAMURE_PACKAGE_DEPENDS libqt6svg6)
# Qt's own dialogs in the user's language.
set(CPACK_DEBIAN_RAMURE_PACKAGE_RECOMMENDS qt6-translations-l10n)
# `ramure-cli render` where there is no display.
set(CPACK_DEBIAN_RAMURE_PACKAGE_SUGGESTS xvfb)
# The module is built for one Python, and stands without the programs.
set(CPACK_DEBIAN_PYTHON3-RAMURE_PACKAGE_NAME python3-ramure)
set(CPACK_DEBIAN_PYTHON3-RAMURE_PACKAGE_SECTION python)
get_property(minor GLOBAL PROPERTY RAMURE_PYTHON_MINOR)
math(EXPR next "${minor} + 1")
set(CPACK_DEBIAN_PYTHON3-RAMURE_PACKAGE_DEPENDS "python3 (>= 3.${minor}), python3 (<< 3.${next}), python3-numpy")
set(CPACK_DEBIAN_PYTHON3-RAMURE_PACKAGE_SUGGESTS ramure)
set(CPACK_COMPONENT_PYTHON3-RAMURE_DESCRIPTION "Trees of Ramure in Python
A species, a seed and an age become a closed mesh, leaves as copies, levels
of detail for games, clips in the wind: the same bytes as ramure-cli, as
arrays of NumPy that share the memory of the library, with the recipe of each
tree as objects.")
include(CPack)
