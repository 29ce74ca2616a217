-- CSV as RFC 4180 has it: fields between commas, quoted ones may hold commas, newlines and "" for a quote.
local Csv = {}

--- Rows as lists of strings, each with .line; lines that start with # before the header are skipped.
--- On bad quoting: nil, line, reason.
function Csv.parse(text)
    local rows, row, at, line = {}, {line = 1}, 1, 1
    while text:sub(at, at) == "#" do
        at = (text:find("\n", at, true) or #text) + 1
        line = line + 1
    end
    row.line = line
    while at <= #text do
        local field
        if text:sub(at, at) == '"' then
            local parts, from = {}, at + 1
            while true do
                local quote = text:find('"', from, true)
                if not quote then return nil, row.line, "a quote is opened and never closed" end
                parts[#parts + 1] = text:sub(from, quote - 1)
                from = quote + 1
                if text:sub(from, from) ~= '"' then break end
                parts[#parts + 1] = '"'
                from = from + 1
            end
            field, at = table.concat(parts), from
        else
            local stop = text:find("[,\n]", at) or #text + 1
            field, at = text:sub(at, stop - 1):gsub("\r$", ""), stop
            if field:find('"', 1, true) then return nil, line, "a quote inside an unquoted field" end
        end
        local _, inside = field:gsub("\n", "")
        line = line + inside
        row[#row + 1] = field
        local next = text:sub(at, at)
        if next == "\r" then at = at + 1; next = text:sub(at, at) end
        if next == "," then
            at = at + 1
        elseif next == "\n" or next == "" then
            rows[#rows + 1] = row
            line, at = line + 1, at + 1
            row = {line = line}
        else
            return nil, line, "text after a closing quote"
        end
    end
    return rows
end

return Csv
