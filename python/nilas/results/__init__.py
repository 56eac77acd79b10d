"""Reading run folders. ``docs/reference/outputs.md`` says what each file and column holds."""
