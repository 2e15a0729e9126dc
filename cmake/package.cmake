# SPDX-License-Identifier: LGPL-2.1-or-later
#
# What "cmake --install" puts below the prefix, and the Debian package of it that
# "./squeal package" makes:
#
#   bin/squeal                 the launcher, which finds the rest from its own place
#   bin/squeal-tribology       a link to the program
#   libexec/squeal             the programs
#   share/squeal/prm           the shipped parameter files with their data
#   share/doc/squeal           licence, changes, pages
#   share/man/man1             manual pages

include(GNUInstallDirs)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY TRUE)
set(CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
    WORLD_EXECUTE)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    ${CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS})

set(_made "${PROJECT_BINARY_DIR}/package")
set(_texts "${PROJECT_SOURCE_DIR}/cmake/package")
set(_programs ${CMAKE_INSTALL_LIBEXECDIR}/squeal)
file(MAKE_DIRECTORY "${_made}")

# A package of every commit is newer than that of the commit before: otherwise apt
# would keep what is installed.
set(SQUEAL_PACKAGE_VERSION "${PROJECT_VERSION}")
set(SQUEAL_PACKAGE_TIME "@0")
if(NOT SQUEAL_REVISION STREQUAL "unknown")
  execute_process(
    COMMAND "${GIT_EXECUTABLE}" show -s --format=%ct HEAD
    WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
    OUTPUT_VARIABLE _seconds
    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  set(SQUEAL_PACKAGE_TIME "@${_seconds}")
  execute_process(
    COMMAND date --utc "--date=${SQUEAL_PACKAGE_TIME}" +%Y%m%d%H%M%S
    OUTPUT_VARIABLE _time
    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  string(APPEND SQUEAL_PACKAGE_VERSION "+git${_time}.${SQUEAL_REVISION}")
endif()
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C date --utc
          "--date=${SQUEAL_PACKAGE_TIME}" --rfc-email
  OUTPUT_VARIABLE SQUEAL_PACKAGE_DATE
  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)

# Who makes a package signs it by Debian's usual variables; without them it names
# no address that could be written to.
set(SQUEAL_PACKAGE_CONTACT "The squeal authors <authors@squeal.invalid>")
if(DEFINED ENV{DEBFULLNAME} AND DEFINED ENV{DEBEMAIL})
  set(SQUEAL_PACKAGE_CONTACT "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif()

# Compressed as Debian asks for.
function(_squeal_compress text destination)
  configure_file("${_texts}/${text}.in" "${_made}/${text}" @ONLY)
  execute_process(
    COMMAND gzip -9nc "${_made}/${text}"
    OUTPUT_FILE "${_made}/${text}.gz" COMMAND_ERROR_IS_FATAL ANY)
  install(FILES "${_made}/${text}.gz" DESTINATION "${destination}")
endfunction()

# _squeal_link(name target directory): a symbolic link in the directory.
function(_squeal_link name target directory)
  file(MAKE_DIRECTORY "${_made}/links/${directory}")
  file(CREATE_LINK "${target}" "${_made}/links/${directory}/${name}" SYMBOLIC)
  install(FILES "${_made}/links/${directory}/${name}"
          DESTINATION "${directory}")
endfunction()

install(PROGRAMS squeal DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS squeal squeal-tribology RUNTIME DESTINATION ${_programs})
_squeal_link(squeal-tribology ../${_programs}/squeal-tribology
             ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY prm DESTINATION ${CMAKE_INSTALL_DATADIR}/squeal
        PATTERN __pycache__ EXCLUDE PATTERN ".*" EXCLUDE PATTERN "*~" EXCLUDE)
install(DIRECTORY doc DESTINATION ${CMAKE_INSTALL_DOCDIR}
        PATTERN __pycache__ EXCLUDE PATTERN ".*" EXCLUDE PATTERN "*~" EXCLUDE)
install(FILES README.md CHANGELOG.md CITATION.cff CONTRIBUTING.md LICENSE
              cmake/package/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})
# Links between pages and parameter files lead to the same places as here.
_squeal_link(prm ../../squeal/prm ${CMAKE_INSTALL_DOCDIR})
_squeal_link(doc ../doc/squeal/doc ${CMAKE_INSTALL_DATADIR}/squeal)
_squeal_compress(changelog ${CMAKE_INSTALL_DOCDIR})
_squeal_compress(squeal.1 ${CMAKE_INSTALL_MANDIR}/man1)
_squeal_compress(squeal-tribology.1 ${CMAKE_INSTALL_MANDIR}/man1)

set(CPACK_GENERATOR DEB)
set(CPACK_VERBATIM_VARIABLES TRUE)
set(CPACK_STRIP_FILES TRUE)
set(CPACK_PACKAGE_NAME squeal)
set(CPACK_PACKAGE_VERSION "${SQUEAL_PACKAGE_VERSION}")
set(CPACK_PACKAGE_CONTACT "${SQUEAL_PACKAGE_CONTACT}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY
    "finite elements for the squeal of disc brakes")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
    "Complex eigenvalue analysis, contact transients with Coulomb friction,\n\
limit cycles and contact fatigue of disc brakes on one scene, with an error\n\
for every number.")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
# Libraries by dpkg-shlibdeps, then what is started or read at run time.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS TRUE)
set(CPACK_DEBIAN_PACKAGE_DEPENDS
    "gnuplot-nox | gnuplot, libjs-three, openmpi-bin, openssh-client")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "paraview")
include(CPack)
