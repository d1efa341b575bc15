# Writes OUT, the code that knows VERSION and the commit of SOURCE; only where it differs, so that nothing else is made
# anew. LEITSTAND_COMMIT of the environment names the commit where SOURCE is no checkout.
set(commit "$ENV{LEITSTAND_COMMIT}")
find_program(GIT git)
if(NOT commit AND GIT)
    execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --show-toplevel --short=12 HEAD
        OUTPUT_VARIABLE told OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
    string(REPLACE "\n" ";" told "${told}")
    list(LENGTH told lines)
    if(NOT failed AND lines EQUAL 2)
        list(GET told 0 top)
        list(GET told 1 head)
        file(REAL_PATH ${SOURCE} source)
        if(top STREQUAL source)  # not the repository of somebody who keeps our sources in theirs
            set(commit ${head})
            execute_process(COMMAND ${GIT} -C ${SOURCE} status --porcelain --untracked-files=no
                OUTPUT_VARIABLE changes ERROR_QUIET)
            if(changes)
                string(APPEND commit "+changes")
            endif()
        endif()
    endif()
endif()
set(code "#include \"core/version/version.h\"

namespace leitstand {

const char* version() {
    return \"${VERSION}\";
}

const char* commit() {
    return \"${commit}\";
}

}  // namespace leitstand
")
if(EXISTS ${OUT})
    file(READ ${OUT} present)
endif()
if(NOT "${present}" STREQUAL "${code}")
    file(WRITE ${OUT} "${code}")
endif()
