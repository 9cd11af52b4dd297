module manifuzz/cp

go 1.22

require github.com/jakecoffman/cp/v2 v2.4.0
