-- The index of the book's search: for each section its address, its title and its words, as one script (a page opened from
-- disk may not fetch a file). Numbers and formulas are left out: nobody searches for them.
local Search = {}

local function quoted(text)
    return '"' .. text:gsub('[%c"\\<]', function(c) return ("\\u%04x"):format(c:byte()) end) .. '"'
end

--- The words of a block, without code and raw HTML.
local function words(block)
    local bare = pandoc.Div({block}):walk {
        CodeBlock = function() return {} end,
        RawBlock = function() return {} end,
        RawInline = function() return pandoc.Space() end,
        Table = function(t)                          -- cells apart
            return pandoc.Para {pandoc.Str((pandoc.write(pandoc.Pandoc {t}, "plain"):gsub("%-%-+", " ")))}
        end,
    }
    local parts = {}
    bare:walk {
        Para = function(p) parts[#parts + 1] = pandoc.utils.stringify(p) end,
        Plain = function(p) parts[#parts + 1] = pandoc.utils.stringify(p) end,
        Header = function(h) parts[#parts + 1] = pandoc.utils.stringify(h) end,
    }
    return table.concat(parts, " ")
end

function Search.write(pages)
    local entries = {}
    for _, page in ipairs(pages) do
        local section = {href = page.name .. ".html", title = page.title, text = {}}
        local function close()
            local text = table.concat(section.text, " "):gsub("%s+", " ")
            entries[#entries + 1] = ("[%s,%s,%s]"):format(quoted(section.href), quoted(section.title), quoted(text))
        end
        for _, block in ipairs(page.doc.blocks) do
            if block.t == "Header" and block.level == 2 then
                close()
                local title = pandoc.utils.stringify(pandoc.Inlines(block.content):filter(function(i) return i.t ~= "RawInline" end))
                local number = page.section_numbers[block.identifier]
                section = {href = page.name .. ".html#" .. block.identifier, text = {},
                           title = (number and number .. " " or page.title .. ": ") .. title:gsub("^%s+", "")}
            elseif not (block.t == "Header" and block.level == 1) then
                section.text[#section.text + 1] = words(block)
            end
        end
        close()
    end
    Page.write("search-index.js", "window.nutshellIndex=[\n" .. table.concat(entries, ",\n") .. "\n];\n")
end

return Search
