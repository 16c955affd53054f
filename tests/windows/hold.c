/* Holds a file open, as other programs of Windows do:  hold.exe FILE alone|read  until its input ends. */
#include <stdio.h>
#include <string.h>
#include <windows.h>

int main(int count, char **words) {
    if (count != 3) return 2;
    /* `alone`: nobody else may open it; `read`: others may read and write, but not remove or replace it. */
    DWORD others = strcmp(words[2], "alone") == 0 ? 0 : FILE_SHARE_READ | FILE_SHARE_WRITE;
    HANDLE file = CreateFileA(words[1], GENERIC_READ, others, NULL, OPEN_EXISTING, 0, NULL);
    if (file == INVALID_HANDLE_VALUE) return 1;
    puts("held");
    fflush(stdout);
    getchar();
    return 0;
}
