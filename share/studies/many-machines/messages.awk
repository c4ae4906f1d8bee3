# The last lines of runs on several ranks as a table; a run on one has none, and no entries here.
#   uniaxial: 4 ranks: 1234 ghost nodes of 31000 at most, 3 neighbours, 45.2 kB and 6 messages a step and rank, 12.3 % of the time waited
BEGIN { OFS = "\t"; print "file", "ghost_nodes", "nodes_of_rank", "neighbours", "kB_a_step", "messages_a_step", "waited_percent" }
/ ranks: .* ghost nodes of / { print substr(FILENAME, 1, length(FILENAME) - length(".messages")), $4, $8 + 0, $11, $13, $16, $22 }
