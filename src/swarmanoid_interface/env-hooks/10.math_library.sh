# Processes of this shell calculate sine, cosine, exponential and similar functions as on any x86-64, so that runs end
# in the same state on any computer: swarmanoid_interface/process/math_library.hpp. Other settings stay, except another
# glibc.cpu.hwcaps: the last one counts.
case "${GLIBC_TUNABLES:-}" in
  *-FMA,-FMA4*) ;;
  *) export GLIBC_TUNABLES="${GLIBC_TUNABLES:+$GLIBC_TUNABLES:}glibc.cpu.hwcaps=-FMA,-FMA4" ;;
esac
# NumPy's own versions of these functions depend on the processor, and on where arrays lie in memory.
case " ${NPY_DISABLE_CPU_FEATURES:-} " in
  *" FMA3 AVX512F AVX512CD AVX512_SKX AVX512_CLX AVX512_CNL AVX512_ICL "*) ;;
  *) export NPY_DISABLE_CPU_FEATURES="${NPY_DISABLE_CPU_FEATURES:+$NPY_DISABLE_CPU_FEATURES }FMA3 AVX512F AVX512CD AVX512_SKX AVX512_CLX AVX512_CNL AVX512_ICL" ;;
esac
