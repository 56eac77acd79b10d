{{#formats}}
reset
set terminal {{terminal}} size {{width}},{{height}} font 'sans,{{font}}' background '#ffffff'
set output '{{file}}'
LW = {{line_width}}
{{{drawing}}}
unset output
{{/formats}}
