-- {{< camera-lab lesson=basis step=3 >}}: Camera Lab in a page of Quarto. In other formats it writes a link.
-- The page's address is the key `camera-lab` of the document, or of _quarto.yml.

local keys = { "figure", "lesson", "step", "view", "lang", "theme", "style" }

local function quoted(text)
  return '"' .. text:gsub("&", "&amp;"):gsub('"', "&quot;"):gsub("<", "&lt;") .. '"'
end

return {
  ["camera-lab"] = function(args, kwargs, meta)
    local page = pandoc.utils.stringify(meta["camera-lab"] or "")
    if page == "" then
      error("camera-lab: write the address of the page as `camera-lab: https://…/` in the header of the document")
    end
    page = page:gsub("/?$", "/", 1)
    local attributes, query = "", ""
    for _, key in ipairs(keys) do
      local value = pandoc.utils.stringify(kwargs[key] or "")
      if value ~= "" then
        attributes = attributes .. " " .. key .. "=" .. quoted(value)
        if key ~= "figure" and key ~= "style" then
          query = query .. (query == "" and "?" or "&") .. key .. "=" .. value
        end
      end
    end
    if quarto.doc.is_format("html:js") then
      return pandoc.RawBlock(
        "html",
        "<script src=" .. quoted(page .. "camera-lab-element.js") .. "></script><camera-lab" .. attributes .. "></camera-lab>"
      )
    end
    return pandoc.Para({ pandoc.Link("Camera Lab", page .. "index.html" .. query) })
  end,
}
