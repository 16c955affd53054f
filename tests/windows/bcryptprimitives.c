/* Wine before 8.10 lacks bcryptprimitives.dll, which every Windows since 7 has and Rust's standard library asks for random
 * numbers. This stands in for it in the tests; no program that is handed out holds it. */
#include <windows.h>

BOOLEAN NTAPI SystemFunction036(PVOID buffer, ULONG length); /* RtlGenRandom, of advapi32 */

__declspec(dllexport) BOOL WINAPI ProcessPrng(PBYTE data, SIZE_T length) { return SystemFunction036(data, (ULONG)length); }
