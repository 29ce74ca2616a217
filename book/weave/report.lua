-- Complaints: all of them are collected, sorted by page and line, printed once; any one stops the build.
local Report = {}
local complaints = {}

--- The line of the next occurrence of `needle` in the page's source. (Pandoc's tree has no line numbers; the same text
--- asked for twice is found twice, in the order of the page.)
function Report.line(page, needle)
    page.found = page.found or {}
    local from = page.found[needle] or 1
    local at = page.text:find(needle, from, true) or page.text:find(needle, 1, true)
    if not at then                                       -- text that pandoc has re-indented: its first line will do
        local first = needle:match("[^\n%s][^\n]*")
        at = first and page.text:find(first, 1, true)
        if not at then return 1 end
    end
    page.found[needle] = at + #needle
    local _, newlines = page.text:sub(1, at):gsub("\n", "")
    return newlines + 1
end

--- A complaint about a line; message is a format for what follows it.
function Report.add(page, line, message, ...)
    if select("#", ...) > 0 then message = message:format(...) end
    complaints[#complaints + 1] = {file = page.file, line = line, message = message, order = #complaints}
end

--- Prints them, sorted. @return true if there were any
function Report.finish()
    table.sort(complaints, function(a, b)
        if a.file ~= b.file then return a.file < b.file end
        if a.line ~= b.line then return a.line < b.line end
        return a.order < b.order
    end)
    for _, c in ipairs(complaints) do
        io.stderr:write(("%s%s:%d: %s\n"):format(Book.prefix, c.file, c.line, c.message))
    end
    return #complaints > 0
end

--- "it has: a, b, c", for complaints about names
function Report.names(set, none)
    local list = {}
    for name in pairs(set) do list[#list + 1] = name end
    table.sort(list)
    if #list > 12 then list = {table.unpack(list, 1, 12)}; list[13] = "…" end
    return #list > 0 and ("it has: " .. table.concat(list, ", ")) or none
end

return Report
