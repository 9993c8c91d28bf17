# Processes of this shell calculate sine, cosine, exponential and similar functions as on any x86-64, so that runs end
# in the same state on any computer: swarmanoid_interface/process/math_library.hpp. Other settings stay, except another
# glibc.cpu.hwcaps: the last one counts.
case "${GLIBC_TUNABLES:-}" in
  *-FMA,-FMA4*) ;;
  *) export GLIBC_TUNABLES="${GLIBC_TUNABLES:+$GLIBC_TUNABLES:}glibc.cpu.hwcaps=-FMA,-FMA4" ;;
esac
